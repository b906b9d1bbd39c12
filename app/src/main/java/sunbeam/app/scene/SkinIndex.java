package sunbeam.app.scene;

import java.util.Optional;
import sunbeam.app.files.input.IndexFile;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.text.Quoted;

/**
 * The refractive index of a skin: the same at all wavelengths, or a file's.
 *
 * @param constant the same at all wavelengths
 * @param file where it is by wavelength, absolute as all files of scenes; empty otherwise
 */
public record SkinIndex(Optional<RefractiveIndex> constant, String file) {
    /** Keratin's. */
    static final SkinIndex KERATIN = of(RefractiveIndex.KERATIN);

    public static SkinIndex of(RefractiveIndex constant) {
        return new SkinIndex(Optional.of(constant), "");
    }

    public static SkinIndex of(String file) {
        return new SkinIndex(Optional.empty(), file);
    }

    /** From {@code 1.56}, {@code 0.97+6.5i} or {@code gold.csv}. */
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

    /** Whether tables of another serve: those of one that is the same at all wavelengths are those of all such. */
    public boolean sharesSpectrum(SkinIndex other) {
        return equals(other) || (!isByWavelength() && !other.isByWavelength());
    }

    public boolean isByWavelength() {
        return constant.isEmpty();
    }
}
