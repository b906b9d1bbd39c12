package sunbeam.app.commands.export;

import io.jhdf.HdfFile;
import io.jhdf.WritableHdfFile;
import io.jhdf.api.WritableNode;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;

/**
 * HDF5: dataset {@code C} of shape (channel, w, v, u), datasets {@code w}, {@code v}, {@code u} and of bands {@code
 * wavelengths_nm}, and attributes that say the rest.
 */
record Hdf5Table(Channels channels) implements ArrayTable {
    @Override
    public Ending ending() {
        return Ending.HDF5;
    }

    @Override
    public long leastBytes(GridShape shape) {
        return shape.allTexels() * channels.count() * Float.BYTES;
    }

    @Override
    public List<Path> write(Path output, Overwrite overwrite, ColorGrid grid, GridBaker baker, TableText text) {
        Map<String, Object> fields =
                channels.fields(text.fields(channels.words() + ": dataset C, axes channel, w, v, u", INTERPOLATION));
        GridShape shape = grid.shape();
        float[][][][] colors = colors(shape, channels.grids(grid, baker));
        return List.of(AtomicFile.writeFile(output, overwrite, file -> {
            try (WritableHdfFile hdf = HdfFile.write(file)) {
                hdf.putDataset("C", colors);
                hdf.putDataset("u", shape.u().values(1));
                hdf.putDataset("v", shape.v().values(1));
                hdf.putDataset("w", shape.depth().values(-1));
                if (channels.kind() == Channels.Kind.SPECTRAL) {
                    hdf.putDataset("wavelengths_nm", channels.bands().nanometers());
                }
                describe(hdf, "", fields);
            } catch (RuntimeException failure) {
                throw new OutputException("cannot write " + output + ": " + failure.getMessage(), failure);
            }
        }));
    }

    /** What is no list, whose numbers are datasets, is an attribute; of what has parts each part. */
    private static void describe(WritableNode node, String prefix, Map<?, ?> fields) {
        fields.forEach((name, value) -> {
            if (value instanceof Map<?, ?> parts) {
                describe(node, prefix + name + "_", parts);
            } else if (!(value instanceof List)) {
                node.putAttribute(prefix + name, value);
            }
        });
    }

    private float[][][][] colors(GridShape shape, List<ColorGrid> grids) {
        int columns = shape.u().count();
        float[][][][] colors =
                new float[channels.count()][shape.depth().count()][shape.v().count()][columns];
        double[] values = new double[channels.count()];
        for (int slice = 0; slice < shape.depth().count(); slice++) {
            for (int texel = 0; texel < shape.texels(); texel++) {
                channels.at(grids, slice, texel, values);
                for (int c = 0; c < values.length; c++) {
                    colors[c][slice][texel / columns][texel % columns] = (float) values[c];
                }
            }
        }
        return colors;
    }
}
