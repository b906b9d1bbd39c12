package jrtr.glsl;

import java.util.Map;
import java.util.Optional;

public final class ShaderTexts {
    private ShaderTexts() {}

    public static ShaderLibrary of(Map<String, String> files) {
        return name -> Optional.ofNullable(files.get(name));
    }
}
