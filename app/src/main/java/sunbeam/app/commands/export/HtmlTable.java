package sunbeam.app.commands.export;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Path;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.gpu.map.DiscDirections;
import sunbeam.app.gpu.picture.AutoExposure;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.precompute.colortable.ColorTable;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/** A page that draws a map and a sphere under a light that the mouse moves; all it needs is in it. */
final class HtmlTable implements TableWriter {
    /** Angle of the first light to the normal, degrees. */
    static final double THETA = 30;

    private static final int MAP_SIDE = 200;
    // Of rounding, in octaves, of a relative error.
    private static final double OCTAVES = 0.5;
    private static final double LEAST_BYTES = 0.3;
    private static final int PAGE_BYTES = 20_000;
    // What graphics cards of telephones have.
    private static final long MOST_TEXELS = 1 << 24;

    private final double tolerance;
    // Of what was packed: each level's table is made once.
    private ColorTable.Level last;
    private QuantizedGrid packed;

    HtmlTable(double tolerance) {
        this.tolerance = tolerance;
    }

    @Override
    public void check(Path output, Overwrite overwrite) {
        Ending.HTML.require("--output", output);
        AtomicFile.checkWritable(output, overwrite);
    }

    @Override
    public long leastBytes(GridShape shape) {
        return shape.allTexels() > MOST_TEXELS ? Long.MAX_VALUE : (long) (LEAST_BYTES * shape.evaluated());
    }

    @Override
    public long bytes(ColorGrid grid) {
        return PAGE_BYTES + 4L * packed(grid).packed().length / 3;
    }

    @Override
    public ColorGrid asRead(ColorGrid grid) {
        return packed(grid).grid();
    }

    private QuantizedGrid packed(ColorGrid grid) {
        if (!grid.level().equals(last)) {
            packed = QuantizedGrid.of(grid, OCTAVES * tolerance);
            last = grid.level();
        }
        return packed;
    }

    @Override
    public List<Path> write(Path output, Overwrite overwrite, ColorGrid grid, GridBaker baker, TableText text) {
        Map<String, Object> table = new LinkedHashMap<>(text.fields(
                "square roots of CIE X, Y, Z of diffracted power, of logarithms in equal steps",
                "square roots linear along u and v, their squares cubic along w"));
        GridShape shape = grid.shape();
        table.put("columns", shape.u().count());
        table.put("rows", shape.v().count());
        table.put("slices", shape.depth().count());
        table.put("octaves", OCTAVES * tolerance);
        table.put("floor", QuantizedGrid.FLOOR);
        table.put("most", packed(grid).most());
        double largest = Math.toDegrees(shape.range().largest());
        table.put("largest", largest);
        table.put("theta", Math.min(THETA, largest));
        table.put("exposure", exposure(text.grid(), Math.min(THETA, largest)));
        Map<String, String> values = new LinkedHashMap<>();
        values.put("PATCH", ShaderText.plain(text.setup().patch().name()));
        values.put("CAPTION", caption(text));
        // In a script element "</" would end it.
        values.put("JSON", new ObjectMapper().valueToTree(table).toString().replace("<", "\\u003c"));
        values.put("SHADER", ShaderText.function("sunbeam.glsl", text, 0) + "\n" + ShaderText.read("display.glsl"));
        values.put("DATA", Base64.getEncoder().encodeToString(packed(grid).packed()));
        String page = ShaderText.filled(ShaderText.read("page.html"), values);
        return List.of(AtomicFile.write(output, overwrite, AtomicFile.StreamContent.of(page)));
    }

    private static String caption(TableText text) {
        return Text.format(
                "Surface %s, light of a coherence length of %s (%s asked): an order is %.2g&deg; wide. %s, mean over"
                        + " all positions of the coherence area. %s. Made by Sunbeam.",
                ShaderText.plain(text.setup().patch().name()),
                Lengths.rounded(text.coherenceLength(), 3),
                Lengths.rounded(text.asked(), 3),
                text.resolutionDegrees(),
                ShaderText.plain(text.setup().cie().description()),
                text.error().replaceFirst("^e", "E"));
    }

    /** As `brdf-map` chooses it. */
    static double exposure(ColorGrid grid, double theta) {
        DiscDirections directions = new DiscDirections(MAP_SIDE, Direction.ofDegrees(theta, 0));
        float[] xyz = new float[ColorGrid.CHANNELS * MAP_SIDE * MAP_SIDE];
        for (int pixel = 0; pixel < MAP_SIDE * MAP_SIDE; pixel++) {
            DirectionPair pair = directions.at(pixel);
            if (pair.cosThetaR() > 0) {
                double gain = Gain.relativeRadiance(pair);
                double[] power = grid.xyz(pair.u(), pair.v(), pair.w());
                for (int c = 0; c < ColorGrid.CHANNELS; c++) {
                    xyz[ColorGrid.CHANNELS * pixel + c] = (float) (gain * power[c]);
                }
            }
        }
        return AutoExposure.of(new LinearPicture(MAP_SIDE, MAP_SIDE, xyz));
    }
}
