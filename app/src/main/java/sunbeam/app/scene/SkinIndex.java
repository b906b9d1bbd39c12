package sunbeam.app.scene;

import java.nio.file.Path;
import java.util.Optional;
import sunbeam.app.files.input.IndexFile;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.text.Text;

/** Refractive index of a skin: a constant, or the absolute name of a file with values by wavelength. */
public record SkinIndex(Optional<RefractiveIndex> constant, String file) {
    static final SkinIndex KERATIN = of(RefractiveIndex.KERATIN);

    public static SkinIndex of(RefractiveIndex constant) {
        return new SkinIndex(Optional.of(constant), "");
    }

    public static SkinIndex of(String file) {
        return new SkinIndex(Optional.empty(), file);
    }

    static SkinIndex parse(String text) {
        try {
            return IndexFile.isName(text) ? of(text.strip()) : of(RefractiveIndex.parse(text));
        } catch (IllegalArgumentException wrong) {
            throw new IllegalArgumentException(Text.quoted(text) + ": " + wrong.getMessage(), wrong);
        }
    }

    /** Returns the constant, or reads the file. */
    public RefractiveIndex values() {
        return constant.orElseGet(() -> IndexFile.read(Path.of(file)));
    }

    String format() {
        return constant.map(RefractiveIndex::describe).orElse(file);
    }

    public boolean isByWavelength() {
        return constant.isEmpty();
    }
}
