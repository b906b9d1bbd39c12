package sunbeam.app.cli.export;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.ExrFile;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.precompute.colortable.NumberFormat;

/** Writes a folder for renderers: shader source that evaluates the color for light and view, and the table as textures. */
record FolderTable(Language language) implements TableWriter {
    // Bytes per evaluated texel in EXR: three half floats, which ZIP compresses by a third.
    private static final double EVALUATED_BYTES = 4;

    /** Factor of the stored roots: without it dark ones would be subnormal half floats. */
    private static final float SCALE = 256;

    private static final String INTERPOLATION =
            "square roots linear along u and v; their squares by the cubic polynomial through the four nearest slices of w";

    enum Language {
        /**
         * GLSL, HLSL and WGSL, with an example page. The KTX2 texture has mip levels of four half floats per texel; coarser levels add a third to the
         * bytes of the finest.
         */
        GLSL(4, 8 * 4 / 3.0),
        /** Open Shading Language, without mip levels: its renderers filter by averaging samples. */
        OSL(0, 0);

        private final int mostDoublings;
        private final double texelBytes;

        Language(int mostDoublings, double texelBytes) {
            this.mostDoublings = mostDoublings;
            this.texelBytes = texelBytes;
        }

        private String ending() {
            return name().toLowerCase(Locale.ROOT);
        }

        private List<String> endings() {
            String function = "." + ending();
            return this == GLSL
                    ? List.of(function, ".hlsl", ".wgsl", ".ktx2", ".exr", ".html", ".md", ".json")
                    : List.of(function, ".exr", ".md", ".json");
        }
    }

    @Override
    public void check(Path output, Overwrite overwrite) {
        OutputFolder.check(output);
        if (Files.isDirectory(output)) {
            group(output, overwrite).checkWritable();
        }
    }

    private FileGroup group(Path folder, Overwrite overwrite) {
        return new FileGroup(folder.resolve("sunbeam"), language.endings(), overwrite);
    }

    @Override
    public GridShape fit(GridShape shape) {
        return shape.padded(language.mostDoublings);
    }

    @Override
    public long leastBytes(GridShape shape) {
        return (long) (language.texelBytes * shape.allTexels() + EVALUATED_BYTES * shape.evaluated());
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
    public List<Path> write(Path output, Overwrite overwrite, ColorGrid grid, GridBaker baker, TableMetadata metadata) {
        Map<String, AtomicFile.StreamContent> files = files(grid, baker, metadata);
        return OutputFolder.filled(output, () -> group(output, overwrite).write(files));
    }

    private Map<String, AtomicFile.StreamContent> files(ColorGrid grid, GridBaker baker, TableMetadata metadata) {
        String json = metadata.json(quantity(), INTERPOLATION);
        GridShape shape = grid.shape();
        int columns = shape.u().count();
        int rows = shape.v().count();
        int slices = shape.depth().count();
        int doublings = Math.min(language.mostDoublings, baker.doublings(grid));
        Map<String, AtomicFile.StreamContent> files = new LinkedHashMap<>();
        String function = ShaderText.function("sunbeam." + language.ending(), metadata, doublings);
        if (language == Language.OSL) {
            files.put(".osl", AtomicFile.StreamContent.of(function));
        } else {
            for (ShaderLanguage each : ShaderLanguage.values()) {
                files.put(each.ending(), AtomicFile.StreamContent.of(each.translate(function)));
            }
        }
        files.put(
                ".exr",
                stream -> ExrFile.ofHalves(columns, rows * slices, halves(grid, 3), json)
                        .write(stream));
        files.put(".md", AtomicFile.StreamContent.of(ShaderText.about(language.ending() + ".md", metadata)));
        files.put(".json", AtomicFile.StreamContent.of(json));
        if (language == Language.GLSL) {
            List<short[]> levels = new ArrayList<>();
            for (int level = 0; level <= doublings; level++) {
                levels.add(halves(level == 0 ? grid : baker.coarser(grid, level), 4));
            }
            files.put(".ktx2", stream -> new Ktx2File(columns, rows, slices, levels, json).write(stream));
            files.put(".html", AtomicFile.StreamContent.of(ShaderText.page("example.html", metadata)));
        }
        return files;
    }

    private String quantity() {
        return "square roots of CIE X, Y, Z of diffracted power, times 256: of sunbeam.exr the slices one below the other, from the"
                + " first w on, rows of ascending v from the top"
                + (language == Language.GLSL
                        ? "; layers of sunbeam.ktx2, whose mip levels have orders twice as wide each"
                        : "");
    }

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
