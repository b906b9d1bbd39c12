package jrtr.scene;

import jrtr.VertexData;

/** Meshes with known analytic normals. */
final class TestMeshes {
    private TestMeshes() {}

    /** The unit sphere: u to the east, v to the north, poles on z. */
    static VertexData sphere(int columns, int rows) {
        int vertices = (columns + 1) * (rows + 1);
        float[] positions = new float[3 * vertices];
        float[] tangents = new float[4 * vertices];
        float[] coordinates = new float[2 * vertices];
        for (int row = 0, i = 0; row <= rows; row++) {
            for (int column = 0; column <= columns; column++, i++) {
                double polar = Math.PI * row / rows;
                double turn = 2 * Math.PI * column / columns;
                positions[3 * i] = (float) (Math.sin(polar) * Math.cos(turn));
                positions[3 * i + 1] = (float) (Math.sin(polar) * Math.sin(turn));
                positions[3 * i + 2] = (float) Math.cos(polar);
                tangents[4 * i] = (float) -Math.sin(turn);
                tangents[4 * i + 1] = (float) Math.cos(turn);
                tangents[4 * i + 3] = 1;
                coordinates[2 * i] = (float) column / columns;
                coordinates[2 * i + 1] = 1 - (float) row / rows;
            }
        }
        return new VertexData(positions, positions.clone(), tangents, coordinates, grid(columns, rows));
    }

    /** Rows go down, columns to the right. */
    private static int[] grid(int columns, int rows) {
        int[] indices = new int[6 * columns * rows];
        int next = 0;
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                int upper = row * (columns + 1) + column;
                int lower = upper + columns + 1;
                for (int index : new int[] {upper, lower, lower + 1, upper, lower + 1, upper + 1}) {
                    indices[next++] = index;
                }
            }
        }
        return indices;
    }

    /** The square from -1 to 1 in the plane z = 0, seen from above; u along x, v along y. */
    static VertexData square() {
        return new VertexData(
                new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0},
                new float[] {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1},
                new float[] {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1},
                new float[] {0, 0, 1, 0, 1, 1, 0, 1},
                new int[] {0, 1, 2, 0, 2, 3});
    }
}
