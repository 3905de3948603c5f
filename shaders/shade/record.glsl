// What is counted of a pixel's rays: src/render/record.h. VERDICT_UNFINISHED is none of the verdicts.
const int VERDICT_UNFINISHED = 7;

uint packed_record(int verdict, int evaluations) {
    return uint(verdict) | uint(evaluations) << 3;
}
