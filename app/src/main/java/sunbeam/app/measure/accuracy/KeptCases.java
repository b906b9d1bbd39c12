package sunbeam.app.measure.accuracy;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.Average;

/** A folder of drawn cases as {@code accuracy --cases} reads it ({@link AccuracyCase}). */
final class KeptCases {
    private static final List<String> ANGLES = List.of("theta_i", "phi_i", "theta_r", "phi_r");

    private final Path folder;
    private final Overwrite overwrite;
    private final StringBuilder index = new StringBuilder("case,patch,options\n");

    /**
     * Cases below a folder, which is made where it is missing.
     *
     * @throws sunbeam.app.files.output.OutputException when it cannot be, or has cases that may not be replaced
     */
    KeptCases(Path folder, Overwrite overwrite) {
        this.folder = folder;
        this.overwrite = overwrite;
        OutputFolder.create(folder);
        AtomicFile.checkWritable(folder.resolve("index.csv"), overwrite);
    }

    /** Writes a case. The exact values are those of the heights and directions that are written, not of those drawn. */
    void add(RandomCase drawn) {
        String name = "seed" + drawn.seed();
        Path own = folder.resolve(name);
        OutputFolder.create(own);
        HeightMap heights = drawn.map().map(height -> (float) height);
        AtomicFile.write(own.resolve("h.tif"), overwrite, stream -> writeTiff(stream, heights));
        AtomicFile.write(own.resolve("p.json"), overwrite, stream -> stream.write(descriptor(heights)));
        RandomCase written = drawn.with(heights);
        double[][] exact = written.exact();
        AtomicFile.write(own.resolve("in.csv"), overwrite, stream -> {
            try (CsvWriter table = new CsvWriter(stream, columns(drawn))) {
                for (int row = 0; row < exact.length; row++) {
                    table.row(row(drawn, drawn.queries().get(row), exact[row]));
                }
            }
        });
        index.append(String.join(",", name, "p.json", options(drawn))).append('\n');
    }

    /** Writes the table of contents. */
    void close() {
        AtomicFile.write(
                folder.resolve("index.csv"),
                overwrite,
                stream -> stream.write(index.toString().getBytes(StandardCharsets.UTF_8)));
    }

    private static byte[] descriptor(HeightMap map) {
        return String.format(
                        Locale.ROOT,
                        "{\"width\": \"%s nm\", \"height\": \"%s nm\", \"heights\": \"h.tif\", \"maxHeight\": \"1 m\","
                                + " \"levelling\": \"none\"}%n",
                        map.width() * 1e9,
                        map.height() * 1e9)
                .getBytes(StandardCharsets.UTF_8);
    }

    private static void writeTiff(OutputStream stream, HeightMap map) throws IOException {
        ImageTypeSpecifier grey = ImageTypeSpecifier.createInterleaved(
                ColorSpace.getInstance(ColorSpace.CS_GRAY), new int[] {0}, DataBuffer.TYPE_FLOAT, false, false);
        BufferedImage image = grey.createBufferedImage(map.columns(), map.rows());
        WritableRaster raster = image.getRaster();
        for (int row = 0; row < map.rows(); row++) {
            for (int column = 0; column < map.columns(); column++) {
                raster.setSample(column, row, 0, (float) map.at(column, row));
            }
        }
        if (!ImageIO.write(image, "tiff", stream)) {
            throw new IOException("this Java writes no TIFF of floats");
        }
    }

    private static List<String> columns(RandomCase drawn) {
        List<String> columns = new ArrayList<>(ANGLES);
        if (drawn.colors()) {
            columns.addAll(AccuracyCase.QUANTITIES.subList(2, 5));
        } else {
            columns.add("wavelength");
            columns.add(
                    drawn.area().average() == Average.ENSEMBLE
                            ? AccuracyCase.QUANTITIES.get(1)
                            : AccuracyCase.QUANTITIES.get(0));
        }
        return columns;
    }

    private static double[] row(RandomCase drawn, Query query, double... exact) {
        DirectionPair pair = query.pair();
        List<Double> cells =
                new ArrayList<>(List.of(theta(pair.wi()), phi(pair.wi()), theta(pair.wr()), phi(pair.wr())));
        if (!drawn.colors()) {
            cells.add(query.wavelength() * 1e9);
        }
        for (double value : exact) {
            cells.add(value);
        }
        return cells.stream().mapToDouble(Double::doubleValue).toArray();
    }

    private static double theta(Direction direction) {
        return Math.toDegrees(Math.atan2(Math.hypot(direction.x(), direction.y()), direction.z()));
    }

    private static double phi(Direction direction) {
        return Math.toDegrees(Math.atan2(direction.y(), direction.x()));
    }

    private static String options(RandomCase drawn) {
        return String.format(
                Locale.ROOT,
                "--coherence-length %snm --window-origin %s --average %s",
                drawn.area().window().coherenceLength() * 1e9,
                drawn.area().origin().toString().toLowerCase(Locale.ROOT),
                drawn.area().average().toString().toLowerCase(Locale.ROOT));
    }
}
