package sunbeam.app.scene;

import java.util.Optional;
import sunbeam.app.files.input.IndexFile;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.text.Quoted;

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
            throw new IllegalArgumentException(Quoted.of(text) + ": " + wrong.getMessage(), wrong);
        }
    }

    String format() {
        return constant.map(RefractiveIndex::describe).orElse(file);
    }

    /** True if tables are shared: for equal files, or any two constants. */
    public boolean sharesSpectrum(SkinIndex other) {
        return equals(other) || (!isByWavelength() && !other.isByWavelength());
    }

    public boolean isByWavelength() {
        return constant.isEmpty();
    }
}
