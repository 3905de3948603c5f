// isomotion as a library: implicit surfaces F(x, y, z; parameters) = 0 that move are drawn, proved
// and exported. No other library's types are in this header and those that it includes.
//
//     const auto scene = isomotion::Scene::load("blobby75", {"output.size=[640, 480]"});
//     isomotion::Device device;
//     isomotion::Renderer(device, scene).draw(scene.poster()).write("blobby75.png");
//
// Lengths are in scene units, times in seconds, frames count from 1. Coordinates of formulas,
// roots and events are those of the formula; those of a placed surface differ from the world's.
//
// Functions throw Error, or std::bad_alloc. Objects but Device, Renderer and Exporter are values
// that never change: copies are cheap, and all threads may use them. A Device and what draws with
// it belong to the thread that made the Device. Several threads may have one each if all are of one
// kind and the first was made before the other threads began. Callbacks must not throw. Proofs and
// bounds hold while processors round to nearest, as they do unless a program changes it.
#pragma once

#include <isomotion/accuracy.h>
#include <isomotion/drawing.h>
#include <isomotion/error.h>
#include <isomotion/page.h>
#include <isomotion/scene.h>
#include <isomotion/sequence.h>
#include <isomotion/topology.h>
