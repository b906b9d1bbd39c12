package jrtr.scene;

/** A part of a scene graph. A node may stand in several groups, and is then drawn once for each. */
public sealed interface Node permits Group, ShapeNode, LightNode {}
