package sunbeam.precompute.method;

import java.util.List;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.MemoryNeed;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.shader.ColorArrays;
import sunbeam.precompute.shader.MethodUse;
import sunbeam.precompute.shader.ShaderTables;

/** A white disc that sends the same light everywhere (Lambert, Photometria, 1760); for comparison only. */
public record LambertMethod() implements Method {
    /** Its name and settings. */
    public static final MethodType TYPE =
            new MethodType("lambert", "a white disc, for comparison only.", List.of(), choices -> new LambertMethod());

    private static final CoherenceWindow WINDOW = GaussianArea.STANDARD.window();

    @Override
    public MethodType type() {
        return TYPE;
    }

    @Override
    public ReferenceMethod exact(HeightMap map) {
        return new ReferenceMethod(GaussianArea.STANDARD);
    }

    @Override
    public Brightness brightness() {
        return Brightness.UNRELATED;
    }

    @Override
    public MethodPlan plan(Surface surface, VisibleRange range) {
        return new Planned(surface.cie());
    }

    /** It needs the colour of the light and nothing else. */
    private record Planned(CieTable cie) implements MethodPlan {
        @Override
        public String summary() {
            return "lambert: a white disc, for comparison only";
        }

        @Override
        public List<String> reasons() {
            return List.of("nothing of the surface is used");
        }

        @Override
        public MemoryNeed memory() {
            return MemoryNeed.of(0, List.of());
        }

        @Override
        public boolean answers(MethodUse use) {
            return use == MethodUse.COLOUR;
        }

        @Override
        public String key(MethodUse use) {
            return "lambert|" + cie.digest();
        }

        @Override
        public ShaderTables tables(MethodUse use, FourierTables fourier) {
            return new ShaderTables.Builder("lambert")
                    .reals("lambertWhite", ColorArrays.cieWhite(cie))
                    .build(WINDOW.sigmaMetres(), WINDOW.specularReach(CieTable.MAXIMUM_WAVELENGTH));
        }
    }
}
