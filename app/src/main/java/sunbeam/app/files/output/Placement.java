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
        hold(written, target).keep();
    }

    /**
     * Takes a free name for a complete file, which keeps its own name, too.
     *
     * @throws FileAlreadyExistsException when the name is taken
     */
    static Held hold(Path written, Path name) throws IOException {
        try {
            Files.createLink(name, written);
            return new Held(written, name, true);
        } catch (FileAlreadyExistsException taken) {
            throw taken;
        } catch (UnsupportedOperationException | FileSystemException noLinks) {
            // File systems without hard links (FAT, some of networks): an empty file holds the name, then goes.
            Files.createFile(name);
            return new Held(written, name, false);
        }
    }

    /**
     * A name that was free and now is the file's.
     *
     * @param linked whether the file is there under both names; else the name holds an empty file
     */
    record Held(Path written, Path name, boolean linked) {
        /** Leaves the file under this name alone. */
        void keep() throws IOException {
            if (linked) {
                deleteOtherName();
                return;
            }
            try {
                replace(written, name);
            } catch (IOException failure) {
                Files.deleteIfExists(name);
                throw failure;
            }
        }

        private void deleteOtherName() {
            try {
                Files.delete(written);
            } catch (IOException twoNames) {
                // The output is there and whole; its temporary name is swept away with those of dead processes.
                return;
            }
        }

        /** Gives the name back. */
        void release() throws IOException {
            Files.deleteIfExists(name);
        }
    }

    private static void replace(Path written, Path target) throws IOException {
        Files.move(written, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }
}
