package sunbeam.app.render;

import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.optics.RefractiveIndex;

/**
 * A part of what a skin with an index by wavelength reflects, in which wavelength and direction separate: the diffracted
 * light of the skin is the sum of its parts' (see {@link ReflectionPart}).
 *
 * @param reflection spectral factor of the light and weights of Schlick's two terms
 * @param digest of the index over the visible wavelengths
 */
public record SkinPart(ReflectionPart reflection, String digest) {

    static List<SkinPart> of(RefractiveIndex index, CieTable cie) {
        float[] reflectances = new float[401];
        IntStream.range(0, reflectances.length)
                .forEach(i -> reflectances[i] = (float) index.reflectance((380 + i) * 1e-9));
        String digest = new Sha256().add(reflectances).hex();
        return ReflectionPart.of(index, cie).stream()
                .map(part -> new SkinPart(part, digest))
                .toList();
    }
}
