package jrtr.scene;

import org.joml.Matrix4fc;

/**
 * A node and the way from its coordinates to the world's.
 *
 * @param node of the graph
 * @param toWorld product of the transformations above it, its own included
 */
record PlacedNode(Node node, Matrix4fc toWorld) {}
