package sunbeam.precompute.method;

import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;
import sunbeam.precompute.units.Lengths;

/**
 * Method {@code gem}, for comparison only: a grating of which only the spacing is known (shaders/method/gem.glsl).
 *
 * @param spacing distance of the grating's lines in metres; they run along y
 * @param window the coherence window, of which the method takes no notice
 */
public record GemPlan(double spacing, CoherenceWindow window) implements MethodPlan {

    @Override
    public String summary() {
        return "gem: lines " + Lengths.format(spacing) + " apart, for comparison only";
    }

    @Override
    public List<String> reasons() {
        return List.of("nothing of the surface is used");
    }

    @Override
    public MemoryNeed memory() {
        return MemoryNeed.of(0, List.of());
    }

    /** It has colours, but no power at a wavelength. */
    @Override
    public boolean answers(MethodUse use) {
        return use == MethodUse.COLOUR;
    }

    @Override
    public String key(MethodUse use) {
        return String.join("|", "gem", Double.toString(spacing), window.toString());
    }

    @Override
    public ShaderTables tables(MethodUse use, FourierTables fourier) {
        ShaderTables.Builder tables = new ShaderTables.Builder("gem");
        Average.COHERENT.defineIn(tables);
        return tables.reals("gemSpacing", spacing)
                .build(window.sigmaMetres(), window.specularReach(CieTable.MAXIMUM_WAVELENGTH));
    }
}
