package sunbeam.app.cli.render;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.precompute.text.Text;

/**
 * Files of a picture, or of an animation's frames in a folder. A taken name gets a number unless the target may exist; with {@code
 * --resume}, existing pictures of the same parameters stay.
 */
record FrameFiles(Path target, boolean isAnimation, boolean mayExist, boolean resumes, Overwrite overwrite) {
    private static final String GIF = "animation.gif";

    Overwrite ofPictures() {
        return mayExist || isAnimation ? overwrite : Overwrite.NUMBER;
    }

    Overwrite ofGif() {
        return resumes ? Overwrite.REPLACE : overwrite;
    }

    /** Refuses what cannot be written, before anything is drawn. */
    void check(int frames) {
        if (isAnimation) {
            OutputFolder.check(target);
            if (mayExist && Files.isDirectory(target)) {
                AtomicFile.checkWritable(gif(target), ofGif());
            }
        }
        if (!resumes && (mayExist || !isAnimation)) {
            pictures(target, frames).forEach(this::checkPicture);
        }
    }

    private void checkPicture(Path file) {
        if (ofPictures() == Overwrite.REFUSE && Files.exists(file)) {
            throw new OutputException.Exists("cannot write " + file
                    + ": it exists; add --resume to keep what is finished, or --force to replace it");
        }
        if (!isAnimation) {
            AtomicFile.checkWritable(file, ofPictures());
        }
    }

    Path claim() {
        return isAnimation ? OutputFolder.claim(target, mayExist) : target;
    }

    List<Path> pictures(Path place, int frames) {
        return !isAnimation
                ? List.of(place)
                : IntStream.rangeClosed(1, frames)
                        .mapToObj(frame -> place.resolve(Text.format("frame-%04d.png", frame)))
                        .toList();
    }

    static Path gif(Path folder) {
        return folder.resolve(GIF);
    }
}
