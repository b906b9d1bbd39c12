package sunbeam.app.files.output;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/**
 * Gives a complete file its name. A name that is taken is never taken away unless that is wanted: looking whether it is
 * free and then renaming would let two writers both succeed, so the name is made by link(2), which fails where there is one.
 */
final class Placement {
    private Placement() {}

    /**
     * Moves a file to its name in the same folder.
     *
     * @return the name, the next free one with {@link Overwrite#NUMBER}
     * @throws FileAlreadyExistsException when the name is taken and may not be replaced
     */
    static Path place(Path written, Path target, Overwrite overwrite) throws IOException {
        if (overwrite == Overwrite.REPLACE) {
            replace(written, target);
            return target;
        }
        if (overwrite == Overwrite.REFUSE) {
            takeFreeName(written, target);
            return target;
        }
        NumberedNames names = NumberedNames.ofFile(target);
        for (int number = 1; number <= NumberedNames.MOST; number++) {
            try {
                takeFreeName(written, names.name(number));
                return names.name(number);
            } catch (FileAlreadyExistsException taken) {
                // The next number, then.
            }
        }
        throw names.exhausted();
    }

    private static void takeFreeName(Path written, Path target) throws IOException {
        try {
            Files.createLink(target, written);
        } catch (FileAlreadyExistsException taken) {
            throw taken;
        } catch (UnsupportedOperationException | FileSystemException noLinks) {
            // File systems without hard links (FAT, some of networks): an empty file holds the name, then goes.
            Files.createFile(target);
            replaceOwn(written, target);
            return;
        }
        try {
            Files.delete(written);
        } catch (IOException twoNames) {
            // The output is there and whole; its temporary name is swept away with those of dead processes.
            return;
        }
    }

    private static void replaceOwn(Path written, Path held) throws IOException {
        try {
            replace(written, held);
        } catch (IOException failure) {
            Files.deleteIfExists(held);
            throw failure;
        }
    }

    private static void replace(Path written, Path target) throws IOException {
        Files.move(written, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }
}
