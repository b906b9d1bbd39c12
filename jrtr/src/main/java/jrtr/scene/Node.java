package jrtr.scene;

/** Node of a scene graph. A node in several groups is drawn once for each. */
public sealed interface Node permits Group, Shape, Light {}
