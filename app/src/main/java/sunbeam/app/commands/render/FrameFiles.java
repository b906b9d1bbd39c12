package sunbeam.app.commands.render;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.OutputExistsException;
import sunbeam.app.files.output.Overwrite;

/** Where an animation's frames go: {@code frame-0001.png} and so on in one folder. */
final class FrameFiles {
    private static final int MOST_NAMES = 10_000;

    private FrameFiles() {}

    /** The folder asked for, or {@code stem}; where that is taken and may not be used, {@code stem-2} and so on. */
    static Path folder(Path asked, String stem, boolean mayUse) {
        if (asked != null) {
            return asked;
        }
        Path plain = Path.of(stem);
        for (int number = 2; !mayUse && Files.exists(plain) && number <= MOST_NAMES; number++) {
            plain = Path.of(stem + "-" + number);
        }
        return plain;
    }

    /** The frames' files in order. */
    static List<Path> names(Path folder, int frames) {
        List<Path> files = new ArrayList<>();
        for (int frame = 1; frame <= frames; frame++) {
            files.add(folder.resolve(String.format(Locale.ROOT, "frame-%04d.png", frame)));
        }
        return files;
    }

    /**
     * Nothing stands where the files will go, or it may be replaced.
     *
     * @throws OutputException for a file that would have to be replaced and may not
     */
    static void requireFree(List<Path> files, Overwrite overwrite) {
        for (Path file : files) {
            requireFree(file, overwrite, "; add --resume to keep what is finished, or --force to replace it");
        }
    }

    /**
     * Which files are to be drawn so that all are there with their parameters.
     *
     * @throws OutputException for a file that would have to be replaced and may not
     */
    static List<Boolean> missing(List<Path> files, List<String> identities, Overwrite overwrite) {
        List<Boolean> missing = new ArrayList<>();
        for (int i = 0; i < files.size(); i++) {
            boolean done = FrameIdentity.matches(files.get(i), identities.get(i));
            if (!done) {
                requireFree(files.get(i), overwrite, " with other parameters; add --force to replace it");
            }
            missing.add(!done);
        }
        return missing;
    }

    private static void requireFree(Path file, Overwrite overwrite, String remedy) {
        if (overwrite == Overwrite.REFUSE && Files.exists(file)) {
            throw new OutputExistsException("cannot write " + file + ": it exists" + remedy);
        }
    }
}
