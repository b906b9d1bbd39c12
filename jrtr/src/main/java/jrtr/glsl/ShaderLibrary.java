package jrtr.glsl;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import jrtr.ShaderException;
import jrtr.ShaderSource;

/**
 * Shader files by name. Names are relative to the library's root and use forward slashes; {@code #include "x.glsl"}
 * means the same file from wherever it is written. In {@code #include "{NAME}.glsl"} the value of a define stands for its
 * name in braces, so that a define can choose a file.
 *
 * <p>{@link #load} expands includes by these rules. A file is included once; later includes of it are skipped, also
 * where the first one stands inside an {@code #if}.
 * {@code #version} stands in the root file only, before any code; the defines follow it. {@code #line} is refused:
 * messages find their file and line without it. Comments are not passed on.
 */
@FunctionalInterface
public interface ShaderLibrary {

    /**
     * The text of a file, or nothing if there is none of that name.
     *
     * @throws UncheckedIOException if the file is there but cannot be read
     */
    Optional<String> text(String name);

    /**
     * As {@link #load(String, Map)} without defines.
     *
     * @throws ShaderException as there
     */
    default ShaderSource load(String name) {
        return load(name, Map.of());
    }

    /**
     * The file with its includes expanded.
     *
     * @param name the root file
     * @param defines becomes {@code #define NAME value} lines after {@code #version}, sorted by name, so that equal
     *     defines give equal text
     * @throws ShaderException for a missing file, a cycle, a misplaced directive (all with file and line), or a define
     *     that is none
     */
    default ShaderSource load(String name, Map<String, String> defines) {
        return new IncludeExpansion(this, defines).expand(name);
    }

    /** This library, and where it lacks a file, another. */
    default ShaderLibrary orElse(ShaderLibrary other) {
        return name -> text(name).or(() -> other.text(name));
    }

    /**
     * Files (UTF-8) from the class path.
     *
     * @param loader whose resources
     * @param folder root, such as {@code sunbeam/shaders}
     */
    static ShaderLibrary ofClassPath(ClassLoader loader, String folder) {
        return name -> {
            try (InputStream stream = loader.getResourceAsStream(folder + "/" + name)) {
                return stream == null
                        ? Optional.empty()
                        : Optional.of(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
            } catch (IOException failure) {
                throw new UncheckedIOException("shader " + name + " cannot be read", failure);
            }
        };
    }
}
