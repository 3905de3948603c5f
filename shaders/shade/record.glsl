// Packs the record of a pixel's rays: src/render/record.h. VERDICT_UNFINISHED is no Verdict.
const int VERDICT_UNFINISHED = 7;

uint packed_record(int verdict, int evaluations) {
    return uint(verdict) | uint(evaluations) << 3;
}
