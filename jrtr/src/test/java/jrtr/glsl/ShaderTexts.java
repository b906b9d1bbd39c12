package jrtr.glsl;

import java.util.Map;
import java.util.Optional;

/** Shader files that a test writes. */
public final class ShaderTexts {
    private ShaderTexts() {}

    /** A library of texts by file name. */
    public static ShaderLibrary of(Map<String, String> files) {
        return name -> Optional.ofNullable(files.get(name));
    }
}
