package jrtr.scene;

/**
 * Node of a scene graph. Nodes are values: a group is made after its children and cannot be changed, so no node contains itself. A node may
 * stand in several groups, and is then drawn in each.
 */
public sealed interface Node permits TransformGroup, Shape, Light, View.Camera {}
