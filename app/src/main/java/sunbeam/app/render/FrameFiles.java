package sunbeam.app.render;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.app.output.OutputException;
import sunbeam.app.output.Overwrite;

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
     * Which files are to be drawn: all, or with {@code resume} those that are not there with their parameters.
     *
     * @throws OutputException for a file that would have to be replaced and may not
     */
    static List<Boolean> missing(List<Path> files, List<String> identities, boolean resume, Overwrite overwrite) {
        List<Boolean> missing = new ArrayList<>();
        for (int i = 0; i < files.size(); i++) {
            Path file = files.get(i);
            boolean done = resume && FrameIdentity.matches(file, identities.get(i));
            if (!done && Files.exists(file) && overwrite == Overwrite.REFUSE) {
                String remedy = resume
                        ? " with other parameters; add --force to replace it"
                        : "; add --resume to keep what is finished, or --force to replace it";
                throw new OutputException("cannot write " + file + ": it exists" + remedy);
            }
            missing.add(!done);
        }
        return missing;
    }
}
