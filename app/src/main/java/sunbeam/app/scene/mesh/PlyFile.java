package sunbeam.app.scene.mesh;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.IntStream;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.text.Quoted;

/**
 * Reader of a PLY file's geometry, text or binary. It reads of element {@code vertex} x, y, z, and optionally nx, ny, nz and texture
 * coordinates (u, v; s, t; texture_u, texture_v; texture_s, texture_t); of element {@code face} the list {@code vertex_indices} or {@code
 * vertex_index}, and optionally the list {@code texcoord} of each corner's texture coordinates; of element {@code tristrips} the list
 * {@code vertex_indices}, in which -1 ends a strip. All else is ignored.
 */
final class PlyFile {
    private static final double[] NO_TEXTURE = {};

    private final PlyHeader header;
    private final DataInputStream stream;
    private final ByteBuffer bytes;
    private final RawMesh.Builder mesh = new RawMesh.Builder();
    private boolean hasCoordinates;
    private boolean hasNormals;
    private String element = "header";

    private int row;

    private PlyFile(PlyHeader header, InputStream stream) {
        this.header = header;
        this.stream = new DataInputStream(stream);
        boolean isLittle = header.encoding() == PlyHeader.Encoding.BINARY_LITTLE_ENDIAN;
        this.bytes = ByteBuffer.allocate(Double.BYTES).order(isLittle ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
    }

    static RawMesh read(Path file) throws IOException {
        try (InputStream stream = new BufferedInputStream(Files.newInputStream(file), 1 << 16)) {
            return new PlyFile(PlyHeader.read(stream), stream).mesh();
        }
    }

    private RawMesh mesh() throws IOException {
        for (PlyHeader.Element next : header.elements()) {
            element = next.name();
            row = 0;
            try {
                rows(next);
            } catch (EOFException end) {
                throw new InputException(
                        element + " " + row + ": the file ends within it; copy or export it again", end);
            } catch (InputException wrong) {
                throw new InputException(element + " " + row + ": " + wrong.getMessage(), wrong);
            }
        }
        return mesh.build();
    }

    private boolean isVertex() {
        return element.equals("vertex");
    }

    private boolean isFace() {
        return element.equals("face");
    }

    private boolean isStrips() {
        return element.equals("tristrips");
    }

    private void rows(PlyHeader.Element table) throws IOException {
        int[] position = {table.column("x"), table.column("y"), table.column("z")};
        int[] normal = {table.column("nx"), table.column("ny"), table.column("nz")};
        int[] coordinates = {
            table.column("u", "s", "texture_u", "texture_s"), table.column("v", "t", "texture_v", "texture_t")
        };
        int corners = table.column("vertex_indices", "vertex_index");
        if (table.count() > RawMesh.Builder.MOST_ELEMENTS && (isVertex() || isFace() || isStrips())) {
            throw new InputException(table.count() + " rows of element " + element + "; at most "
                    + RawMesh.Builder.MOST_ELEMENTS + " can be used, so simplify the mesh");
        }
        if (isVertex()) {
            hasCoordinates = areThere(coordinates);
            hasNormals = areThere(normal);
            InputException.refuseIf(!areThere(position), "it has not x, y and z; export the mesh again");
        } else if ((isFace() || isStrips()) && corners < 0) {
            throw new InputException("it has no list vertex_indices; export the mesh again");
        }
        int width = table.properties().size();
        if (width == 0) {
            return;
        }
        int texture = table.column("texcoord");
        double[][] values = new double[width][];
        for (; row < table.count(); row++) {
            for (int column = 0; column < width; column++) {
                values[column] = next(table.properties().get(column), values[column]);
            }
            if (isVertex()) {
                mesh.addPosition(numbers(values, position));
                if (hasNormals) {
                    mesh.addNormal(numbers(values, normal));
                }
                if (hasCoordinates) {
                    mesh.addTextureCoordinate(numbers(values, coordinates));
                }
            } else if (isFace()) {
                face(values[corners], texture < 0 ? NO_TEXTURE : values[texture]);
            } else if (isStrips()) {
                strips(values[corners]);
            }
        }
    }

    private static boolean areThere(int... columns) {
        return IntStream.of(columns).allMatch(column -> column >= 0);
    }

    /** The previous row's array is reused if it has the right length. */
    private double[] next(PlyHeader.Property property, double[] reusable) throws IOException {
        double length = property.length().isPresent() ? number(property.length().get()) : 1;
        int most = isStrips() ? 3 * RawMesh.Builder.MOST_ELEMENTS : 2 * RawMesh.Builder.MOST_POLYGON_CORNERS;
        if (!(length >= 0 && length <= most) || length != Math.rint(length)) {
            throw new InputException("a list of " + length + " numbers; 0 to " + most + " can be used");
        }
        double[] values = reusable != null && reusable.length == (int) length ? reusable : new double[(int) length];
        for (int i = 0; i < values.length; i++) {
            values[i] = number(property.type());
        }
        return values;
    }

    private static double[] numbers(double[][] values, int... columns) {
        return IntStream.of(columns)
                .mapToDouble(column -> {
                    InputException.refuseIf(
                            values[column].length != 1, "a list where a number belongs; export the mesh again");
                    return values[column][0];
                })
                .toArray();
    }

    /** @param corners -1 or the list's end ends a strip. Every second triangle has two corners exchanged */
    private void strips(double[] corners) {
        int start = 0;
        for (int i = 0; i < corners.length; i++) {
            if (corners[i] == -1) {
                start = i + 1;
            } else if (i - start >= 2) {
                int odd = (i - start) % 2;
                face(new double[] {corners[i - 2], corners[i - 1 + odd], corners[i - odd]}, NO_TEXTURE);
            }
        }
    }

    private void face(double[] corners, double[] texture) {
        int count = corners.length;
        RawMesh.Builder.requireCorners(count);
        boolean ownTexture = texture.length > 0;
        if (ownTexture && texture.length != 2 * count) {
            throw new InputException(
                    texture.length + " texture coordinates of " + count + " corners; give two for each");
        }
        int[] polygon = new int[3 * count];
        for (int i = 0; i < count; i++) {
            int vertex = vertex(corners[i]);
            int coordinate = ownTexture ? mesh.textureCoordinates() : hasCoordinates ? vertex : -1;
            if (ownTexture) {
                mesh.addTextureCoordinate(texture[2 * i], texture[2 * i + 1]);
            }
            polygon[3 * i] = vertex;
            polygon[3 * i + 1] = coordinate;
            polygon[3 * i + 2] = hasNormals ? vertex : -1;
        }
        mesh.addFace(polygon);
    }

    private int vertex(double index) {
        if (!(index >= 0 && index < mesh.positions()) || index != Math.rint(index)) {
            throw new InputException("it names vertex " + index + " but " + mesh.positions()
                    + " are given above it; repair the mesh or export it again");
        }
        return (int) index;
    }

    private double number(SampleType type) throws IOException {
        if (header.encoding() == PlyHeader.Encoding.ASCII) {
            return word();
        }
        stream.readFully(bytes.array(), 0, type.size());
        return type.decode(bytes, 0);
    }

    private double word() throws IOException {
        StringBuilder word = new StringBuilder();
        int next = stream.read();
        while (next >= 0 && next <= ' ') {
            next = stream.read();
        }
        while (next > ' ' && word.length() <= 60) {
            word.append((char) next);
            next = stream.read();
        }
        if (word.isEmpty()) {
            throw new EOFException();
        }
        try {
            return Double.parseDouble(word.toString());
        } catch (NumberFormatException wrong) {
            throw new InputException(Quoted.of(word.toString()) + " is no number; export the mesh again", wrong);
        }
    }
}
