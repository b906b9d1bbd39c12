package sunbeam.app.files.output;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;

/** What stands under the names that outputs shall get. */
final class Targets {
    private Targets() {}

    /** @throws OutputException when the target is a folder, exists and may not be replaced, or its folder is missing */
    static void check(Path target, Overwrite overwrite) {
        if (StandardOutput.isMeant(target)) {
            return;
        }
        if (Files.isDirectory(target)) {
            throw new OutputException("cannot write " + target + ": it is a folder; name a file in it");
        }
        Path folder = folderOf(target);
        if (!Files.exists(folder)) {
            throw new OutputException(
                    "cannot write " + target + ": the folder " + folder + " does not exist; create it first");
        }
        if (!Files.isDirectory(folder)) {
            throw new OutputException("cannot write " + target + ": " + folder + " is not a folder");
        }
        if (!Files.exists(target, LinkOption.NOFOLLOW_LINKS) || isDevice(target)) {
            return;
        }
        if (overwrite == Overwrite.REFUSE) {
            throw OutputException.of(target, new FileAlreadyExistsException(target.toString()));
        }
        if (overwrite == Overwrite.REPLACE && !Files.isWritable(target)) {
            throw new OutputException("cannot write " + target + ": it is write-protected; choose another name");
        }
    }

    /** One look, whose failure is told: a file that is taken for a device would be written over in place. */
    static boolean isDevice(Path target) {
        try {
            return Files.readAttributes(target, BasicFileAttributes.class).isOther();
        } catch (NoSuchFileException free) {
            return false;
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        }
    }

    static Path folderOf(Path target) {
        Path folder = target.toAbsolutePath().getParent();
        return folder != null ? folder : target.toAbsolutePath();
    }
}
