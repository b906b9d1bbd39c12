package sunbeam.app.commands.export;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.ExrFile;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.units.Lengths;

/** A folder for renderers: a function in GLSL, its table as a texture with mip levels, a page that uses it. */
final class GlslTable implements TableWriter {
    private static final List<String> ENDINGS = List.of(".glsl", ".ktx2", ".exr", ".html", ".md", ".json");
    private static final int MOST_DOUBLINGS = 4;
    // Four half floats a texel, a third of that for mip levels; and three, which ZIP makes about two of.
    private static final double TEXEL_BYTES = 8 * 4 / 3.0;
    private static final double EVALUATED_BYTES = 4;
    private static final float SCALE = 256;

    @Override
    public void check(Path output, Overwrite overwrite) {
        OutputFolder.check(output);
        if (Files.isDirectory(output)) {
            group(output, overwrite).checkWritable();
        }
    }

    private static FileGroup group(Path folder, Overwrite overwrite) {
        return new FileGroup(folder.resolve("sunbeam"), ENDINGS, overwrite);
    }

    @Override
    public GridShape fitted(GridShape shape) {
        return shape.padded(MOST_DOUBLINGS);
    }

    @Override
    public long leastBytes(GridShape shape) {
        return (long) (TEXEL_BYTES * shape.allTexels() + EVALUATED_BYTES * shape.evaluated());
    }

    @Override
    public ColorGrid asRead(ColorGrid grid) {
        ColorGrid read = ColorGrid.empty(grid.level(), grid.shape());
        float scale = scale(grid);
        for (int slice = 0; slice < read.roots().length; slice++) {
            float[] roots = grid.roots()[slice];
            for (int i = 0; i < roots.length; i++) {
                read.roots()[slice][i] = NumberFormat.ofHalf(NumberFormat.half(scale * roots[i])) / scale;
            }
        }
        return read;
    }

    private static float scale(ColorGrid grid) {
        return SCALE * (float) Math.sqrt(grid.level().scale());
    }

    @Override
    public List<Path> write(Path output, Overwrite overwrite, ColorGrid grid, GridBaker baker, TableText text) {
        int doublings = Math.min(MOST_DOUBLINGS, baker.doublings(grid));
        List<short[]> levels = new ArrayList<>();
        for (int level = 0; level <= doublings; level++) {
            levels.add(halves(level == 0 ? grid : baker.coarser(grid, level), 4));
        }
        String json = text.json(
                "square roots of CIE X, Y, Z of diffracted power, times 256: layers of sunbeam.ktx2, from the first w on; of"
                        + " sunbeam.exr the slices one below the other, rows of ascending v from the top. Each mip level has orders"
                        + " twice as wide",
                "square roots linear along u and v; their squares by the cubic polynomial through the four nearest slices of w");
        GridShape shape = grid.shape();
        int columns = shape.u().count();
        int rows = shape.v().count();
        int slices = shape.depth().count();
        Map<String, AtomicFile.StreamContent> files = new LinkedHashMap<>();
        files.put(".glsl", plain(ShaderText.function(text, doublings)));
        files.put(".ktx2", stream -> new Ktx2File(columns, rows, slices, levels, json).write(stream));
        files.put(
                ".exr",
                stream -> ExrFile.ofHalves(columns, rows * slices, halves(grid, 3), json)
                        .write(stream));
        files.put(
                ".html",
                plain(ShaderText.filled(ShaderText.read("example.html"), Map.of("EXPOSURE", String.valueOf((float)
                        HtmlTable.exposure(text.grid(), HtmlTable.THETA))))));
        files.put(
                ".md",
                plain(ShaderText.filled(
                        ShaderText.read("example.md"),
                        Map.of(
                                "PATCH", ShaderText.plain(text.setup().patch().name()),
                                "LENGTH", Lengths.rounded(text.coherenceLength(), 3),
                                "ERROR", text.error()))));
        files.put(".json", plain(json));
        boolean isNew = !Files.exists(output);
        OutputFolder.create(output);
        try {
            return group(output, overwrite).write(files);
        } finally {
            if (isNew) {
                deleteIfEmpty(output);
            }
        }
    }

    private static AtomicFile.StreamContent plain(String text) {
        return stream -> stream.write(text.getBytes(StandardCharsets.UTF_8));
    }

    private static void deleteIfEmpty(Path folder) {
        try {
            Files.deleteIfExists(folder);
        } catch (DirectoryNotEmptyException written) {
            return;
        } catch (IOException failure) {
            throw OutputException.of(folder, failure);
        }
    }

    /** All slices; a fourth channel is 1. */
    private static short[] halves(ColorGrid grid, int channels) {
        int texels = grid.shape().texels();
        float scale = scale(grid);
        short one = NumberFormat.half(1);
        short[] halves = new short[Math.multiplyExact(Math.multiplyExact(texels, channels), grid.roots().length)];
        int at = 0;
        for (float[] roots : grid.roots()) {
            for (int texel = 0; texel < texels; texel++) {
                for (int c = 0; c < channels; c++) {
                    halves[at++] = c < ColorGrid.CHANNELS
                            ? NumberFormat.half(scale * roots[ColorGrid.CHANNELS * texel + c])
                            : one;
                }
            }
        }
        return halves;
    }
}
