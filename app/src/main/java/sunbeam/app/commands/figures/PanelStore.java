package sunbeam.app.commands.figures;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.OutputExistsException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.gpu.picture.PictureParameters;
import sunbeam.app.terminal.Version;
import sunbeam.precompute.files.Sha256;

/** The folder of pictures: what is there already with its parameters is kept, so that a run goes on where one ended. */
final class PanelStore {
    static final String CAPTION = "Caption";

    // Another look, other pictures: what was drawn in an older one is drawn anew.
    private static final String LOOK = "annotated";

    private final Path folder;
    private final int size;
    private final Overwrite overwrite;
    private final FigurePatches patches;

    PanelStore(Path folder, int size, Overwrite overwrite, FigurePatches patches) {
        this.folder = folder;
        this.size = size;
        this.overwrite = overwrite;
        this.patches = patches;
    }

    /** The texts of a panel's picture where it is there. */
    Optional<Map<String, String>> finished(Panel panel) {
        Path file = panel.file(folder);
        // Without a file there is no need to load the patch.
        return Files.exists(file) ? PictureParameters.find(file, hash(panel)) : Optional.empty();
    }

    /**
     * Checks that a panel that is to be drawn may be written.
     *
     * @throws OutputException for another picture of its name
     */
    void requireFree(Panel panel) {
        Path file = panel.file(folder);
        if (overwrite == Overwrite.REFUSE && Files.exists(file)) {
            throw new OutputExistsException("cannot write " + file
                    + ": it exists, with other parameters; add --force to replace it, or choose another --output");
        }
    }

    /** Writes a panel's picture; returns its texts. */
    Map<String, String> write(Panel panel, BufferedImage image, Map<String, String> text) {
        Map<String, String> all = new LinkedHashMap<>();
        all.put("Title", panel.label());
        all.put("Patch", patches.setup(panel.role()).patch().source());
        all.putAll(text);
        all.put(PictureParameters.KEYWORD, hash(panel));
        PngWriter.write(panel.file(folder), overwrite, image, all);
        return all;
    }

    private String hash(Panel panel) {
        return Sha256.of(String.join(
                "|",
                Version.number(),
                LOOK,
                Integer.toString(size),
                patches.setup(panel.role()).patch().digest(),
                patches.azimuth(panel.role()).toString(),
                panel.toString()));
    }
}
