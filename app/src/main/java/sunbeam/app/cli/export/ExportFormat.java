package sunbeam.app.cli.export;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;

enum ExportFormat {
    NPZ("100MB", 0.02, Ending.NPZ),
    BSDF("100MB", 0.05, Ending.BSDF),
    HTML("1MB", 0.05, Ending.HTML),
    GLSL("50MB", 0.05, null),
    OSL("50MB", 0.05, null);

    private final String size;
    private final double tolerance;
    /** Ending of the file; null for a folder. */
    private final Ending ending;

    ExportFormat(String size, double tolerance, Ending ending) {
        this.size = size;
        this.tolerance = tolerance;
        this.ending = ending;
    }

    String size() {
        return size;
    }

    double tolerance() {
        return tolerance;
    }

    boolean dividesByLight() {
        return this == NPZ || this == BSDF;
    }

    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Refuses a wrong file name or an unwritable output. */
    void check(Path output, Overwrite overwrite) {
        if (ending != null) {
            ending.require("--output", output);
            AtomicFile.checkWritable(output, overwrite);
            return;
        }
        OutputFolder.check(output);
        if (Files.isDirectory(output)) {
            group(output, overwrite).checkWritable();
        }
    }

    List<Path> write(Path output, Overwrite overwrite, Map<String, AtomicFile.StreamContent> files) {
        return ending != null
                ? List.of(AtomicFile.write(
                        output, overwrite, files.values().iterator().next()))
                : OutputFolder.filled(output, () -> group(output, overwrite).write(files));
    }

    private FileGroup group(Path folder, Overwrite overwrite) {
        List<String> endings = this == GLSL
                ? List.of(".glsl", ".hlsl", ".wgsl", ".ktx2", ".exr", ".html", ".md", ".json")
                : List.of(".osl", ".exr", ".md", ".json");
        return new FileGroup(folder.resolve("sunbeam"), endings, overwrite);
    }
}
