package sunbeam.app.render;

import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.cli.AngleConverter;
import sunbeam.app.cli.LengthConverter;
import sunbeam.app.cli.UsageException;
import sunbeam.app.mesh.BuiltInMeshes;
import sunbeam.app.scene.Blend;
import sunbeam.app.scene.Scene;
import sunbeam.app.texture.BodyTextures;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.Tolerances;
import sunbeam.precompute.units.Decimals;

/** Options that stand above what the scene says; to be used as a picocli mixin. */
public final class SceneOverrides {
    @Option(names = "--mesh", paramLabel = "MESH", description = "snake, plane, sphere, cylinder, or an OBJ file.")
    private String mesh;

    @Option(
            names = "--patch",
            paramLabel = "PATCH",
            description =
                    "The surface: a built-in patch, a descriptor (.json), or an image with --width and --max-height.")
    private String patch;

    @Option(
            names = "--width",
            paramLabel = "LENGTH",
            description = "Extent of the patch's image along x, such as 65um.")
    private String width;

    @Option(names = "--height", paramLabel = "LENGTH", description = "Its extent along y. Default: square pixels.")
    private String height;

    @Option(names = "--max-height", paramLabel = "LENGTH", description = "Height of its full scale, such as 375nm.")
    private String maxHeight;

    @Option(names = "--channel", paramLabel = "CHANNEL", description = "Its channel that holds the heights.")
    private String channel;

    @Option(names = "--level", paramLabel = "KIND", description = "What is subtracted from its heights.")
    private String level;

    @Option(
            names = "--texture",
            paramLabel = "TEXTURE",
            description = "Colours of the body: elaphe, xenopeltis, none, or an image file.")
    private String texture;

    @Mixin
    private MethodOverrides method;

    @Option(names = "--tolerance", paramLabel = "ERROR", description = "Relative error of the diffracted colour.")
    private Double tolerance;

    @Option(names = "--average", paramLabel = "KIND", description = "coherent or ensemble.")
    private Average average;

    @Option(
            names = "--coherence-length",
            paramLabel = "LENGTH",
            converter = LengthConverter.class,
            description = "Four standard deviations of the coherence window, 100nm to 10mm.")
    private Double coherenceLength;

    @Option(
            names = "--rotate-patch",
            paramLabel = "ANGLE",
            converter = AngleConverter.class,
            description = "Turn of the nanostructure in the tangent plane in degrees, counter-clockwise from outside.")
    private Double rotatePatch;

    @Option(names = "--exposure", paramLabel = "FACTOR", description = "Factor for the linear colours, or auto.")
    private String exposure;

    @Option(names = "--diffraction-weight", paramLabel = "W", description = "Factor of the diffracted light.")
    private Double diffraction;

    @Option(names = "--texture-weight", paramLabel = "W", description = "Factor of the body's texture.")
    private Double textureWeight;

    @Option(names = "--diffuse-weight", paramLabel = "W", description = "Share of Lambert's reflection on the body.")
    private Double diffuse;

    @Option(names = "--ambient-weight", paramLabel = "W", description = "Share of light from everywhere.")
    private Double ambient;

    /**
     * The scene as the options have it.
     *
     * @throws UsageException for a value that cannot be used
     */
    Scene apply(Scene scene) {
        Scene result = method.apply(scene, plan(scene.plan())).withBlend(blend(scene.blend()));
        result = mesh == null ? result : result.withMesh(name(mesh, BuiltInMeshes.names()));
        result = texture == null ? result : result.withTexture(name(texture, BodyTextures.names()));
        result = rotatePatch == null ? result : result.withRotatePatch(rotatePatch);
        result = exposure == null ? result : result.withExposure(parseExposure());
        return patch(result);
    }

    private Scene patch(Scene scene) {
        boolean scaled = width != null || height != null || maxHeight != null || channel != null || level != null;
        if (patch != null) {
            String found = name(patch, BuiltInPatches.names());
            return scene.withPatch(PatchRequest.parse(found, width, height, maxHeight, channel, level));
        }
        if (scaled) {
            throw new UsageException("--width, --height, --max-height, --channel and --level need --patch");
        }
        return scene;
    }

    /** Scenes name files absolutely. */
    private static String name(String given, Iterable<String> builtIn) {
        for (String known : builtIn) {
            if (known.equals(given)) {
                return given;
            }
        }
        return Path.of(given).toAbsolutePath().normalize().toString();
    }

    private PlanRequest plan(PlanRequest plan) {
        check("--tolerance", tolerance, Tolerances.FINEST, Tolerances.COARSEST);
        check("--coherence-length", coherenceLength, 100e-9, 10e-3);
        if (tolerance != null && plan.isThesis()) {
            throw new UsageException("--tolerance " + tolerance
                    + " contradicts the scene's preset thesis, whose choices keep no tolerance; leave it out");
        }
        return new PlanRequest(
                plan.preset(),
                tolerance == null ? plan.tolerance() : tolerance,
                plan.expansion(),
                plan.terms(),
                plan.radius(),
                plan.anchor(),
                plan.wavelengthStep(),
                plan.origin(),
                coherenceLength == null ? plan.coherenceLength() : OptionalDouble.of(coherenceLength),
                average == null ? plan.average() : Optional.of(average));
    }

    private Blend blend(Blend blend) {
        check("--diffraction-weight", diffraction, 0, Blend.LARGEST);
        check("--texture-weight", textureWeight, 0, Blend.LARGEST);
        check("--diffuse-weight", diffuse, 0, Blend.LARGEST);
        check("--ambient-weight", ambient, 0, Blend.LARGEST);
        return new Blend(
                diffraction == null ? blend.diffraction() : diffraction,
                textureWeight == null ? blend.texture() : textureWeight,
                diffuse == null ? blend.diffuse() : diffuse,
                ambient == null ? blend.ambient() : ambient);
    }

    private OptionalDouble parseExposure() {
        if (exposure.equals("auto")) {
            return OptionalDouble.empty();
        }
        double value = Decimals.parse(exposure).orElse(Double.NaN);
        if (!(value > 0)) {
            throw new UsageException("--exposure '" + exposure + "' is neither auto nor a positive number");
        }
        return OptionalDouble.of(value);
    }

    private static void check(String option, Double value, double least, double most) {
        if (value != null && !(value >= least && value <= most)) {
            throw new UsageException("%s %s is out of range; give %s to %s"
                    .formatted(option, Decimals.format(value), Decimals.format(least), Decimals.format(most)));
        }
    }
}
