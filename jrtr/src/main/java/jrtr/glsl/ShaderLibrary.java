package jrtr.glsl;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import jrtr.GraphicsException;
import jrtr.ShaderSource;

/**
 * Shader files by name. Names are relative to the library's root and use forward slashes; {@code #include "x.glsl"} means the same file in
 * every folder. In {@code #include "{NAME}.glsl"} the name in braces is replaced by the define's value, so that a define can select a file.
 *
 * <p>{@link #load} expands includes by these rules. A file is included once. Later includes of it are skipped, even if the first one stands
 * inside an {@code #if}. {@code #version} stands in the root file only, before any code; the defines follow it. Comments are removed.
 * Messages get their file and line from {@link ShaderSource}, so {@code #line} must not be used.
 */
@FunctionalInterface
public interface ShaderLibrary {

    /** Throws {@link UncheckedIOException} if the file exists but cannot be read. */
    Optional<String> text(String name);

    default ShaderSource load(String name) {
        return load(name, Map.of());
    }

    /**
     * Loads a file and expands its includes. Defines become {@code #define NAME value} lines after {@code #version}, sorted by name. A
     * missing file or define is a {@link GraphicsException} with file and line.
     */
    default ShaderSource load(String name, Map<String, String> defines) {
        return new IncludeExpansion(this, defines).expand(name);
    }

    default ShaderLibrary orElse(ShaderLibrary other) {
        return name -> text(name).or(() -> other.text(name));
    }

    /** Returns a library of files (UTF-8) in a folder of the class path, such as {@code sunbeam/shaders}. */
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

    /** Returns the engine's files, such as {@code jrtr/surface.glsl}, which fragment shaders of meshes include. */
    static ShaderLibrary ofEngine() {
        String prefix = "jrtr/";
        ShaderLibrary files = ofClassPath(ShaderLibrary.class.getClassLoader(), "jrtr/shaders");
        return name -> name.startsWith(prefix) ? files.text(name.substring(prefix.length())) : Optional.empty();
    }
}
