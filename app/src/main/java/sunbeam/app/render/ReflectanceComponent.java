package sunbeam.app.render;

import java.util.List;
import java.util.stream.IntStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.ReflectionPart;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.optics.RefractiveIndex;

/**
 * Component of the reflectance of a skin with an index by wavelength: a product of one function of wavelength and one of direction. The
 * skin's diffracted light is the sum over its components (see {@link ReflectionPart}).
 *
 * @param reflection spectral factor of the light and weights of Schlick's two terms
 * @param digest hash of the index over the visible wavelengths
 */
public record ReflectanceComponent(ReflectionPart reflection, String digest) {

    static List<ReflectanceComponent> of(RefractiveIndex index, CieTable cie) {
        float[] reflectances = new float[401];
        IntStream.range(0, reflectances.length)
                .forEach(i -> reflectances[i] = (float) index.reflectance((380 + i) * 1e-9));
        String digest = new Sha256().add(reflectances).hex();
        return ReflectionPart.of(index, cie).stream()
                .map(part -> new ReflectanceComponent(part, digest))
                .toList();
    }
}
