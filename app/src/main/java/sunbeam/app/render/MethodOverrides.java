package sunbeam.app.render;

import picocli.CommandLine.Option;
import sunbeam.app.cli.LengthConverter;
import sunbeam.app.cli.OptionOrigin;
import sunbeam.app.cli.UsageException;
import sunbeam.app.gpu.MethodKind;
import sunbeam.app.scene.Scene;
import sunbeam.app.setup.MethodBridge;
import sunbeam.app.setup.MethodRequest;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.resample.PeriodInterpolation;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** A method that stands above the scene's; to be used as a picocli mixin. */
public final class MethodOverrides {
    @Option(names = "--method", paramLabel = "METHOD", description = "full, nmm, pq or gem; see docs/methods.md.")
    private MethodKind kind;

    @Option(names = "--interpolation", paramLabel = "KIND", description = "For --method pq: sinc (default) or linear.")
    private PeriodInterpolation interpolation;

    @Option(
            names = "--replicas",
            paramLabel = "Q",
            description = "For --method pq: repeat the patch Q times along both axes.")
    private Integer replicas;

    @Option(
            names = "--spacing",
            paramLabel = "LENGTH",
            converter = LengthConverter.class,
            description = "For --method gem: distance of the grating's lines, which run along the patch's y.")
    private Double spacing;

    /**
     * The scene with this method, where one is given, and a plan.
     *
     * @throws UsageException for a value that cannot be used, or that does not belong to the method
     */
    Scene apply(Scene scene, PlanRequest plan) {
        if (kind == null) {
            if (interpolation != null || replicas != null || spacing != null) {
                throw new UsageException("--interpolation, --replicas and --spacing need --method");
            }
            return scene.withPlan(plan);
        }
        if (kind == MethodKind.REFERENCE) {
            throw new UsageException(
                    "--method reference evaluates single directions; use it with 'reflectance', and full here");
        }
        if (kind == MethodKind.PQ && plan.average().orElse(Average.COHERENT) == Average.ENSEMBLE) {
            throw new UsageException("--method pq has no ensemble average, which the scene asks for; add"
                    + " --average coherent, or use --method full");
        }
        return scene.withMethod(request(), plan);
    }

    private MethodRequest request() {
        Choices choices = with(
                Choices.at(OptionOrigin.INSTANCE),
                Methods.METHOD,
                Methods.METHOD.kind().parse(kind.label()));
        choices = with(choices, MethodSettings.INTERPOLATION, interpolation);
        choices = with(choices, MethodSettings.REPLICAS, replicas);
        choices = with(choices, MethodSettings.SPACING, spacing);
        return MethodBridge.methodRequest(Methods.of(choices));
    }

    private static <T> Choices with(Choices choices, Setting<T> setting, T value) {
        return value == null ? choices : choices.with(setting, value);
    }
}
