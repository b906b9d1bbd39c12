package jrtr.scene;

/** A part of a scene graph. It may stand in several groups, and is then drawn once for each. */
public sealed interface Node permits Group, Shape, Light {}
