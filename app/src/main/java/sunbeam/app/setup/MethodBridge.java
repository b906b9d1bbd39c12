package sunbeam.app.setup;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.app.gpu.MethodKind;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.GemMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.plan.Accuracy;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.PlanRequest;
import sunbeam.precompute.plan.ReplicatedArea;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.plan.Tolerances;
import sunbeam.precompute.resample.PeriodInterpolation;

/** From methods to the requests that stood for them before. Goes away with these, once methods plan themselves. */
public final class MethodBridge {
    private MethodBridge() {}

    /** Which method, and what belongs to it alone. */
    public static MethodRequest methodRequest(Method method) {
        MethodRequest plain = MethodRequest.of(kind(method));
        PeriodInterpolation interpolation = method instanceof PqMethod pq ? pq.interpolation() : plain.interpolation();
        OptionalDouble spacing = method instanceof GemMethod gem ? gem.spacing() : OptionalDouble.empty();
        return new MethodRequest(plain.kind(), interpolation, replicas(method), spacing);
    }

    private static OptionalInt replicas(Method method) {
        if (method instanceof PqMethod pq && pq.repetition() instanceof PqMethod.Times times) {
            return OptionalInt.of(times.replicas());
        }
        return method instanceof ReferenceMethod reference && reference.area() instanceof ReplicatedArea replicated
                ? OptionalInt.of(replicated.replicas().alongX())
                : OptionalInt.empty();
    }

    private static MethodKind kind(Method method) {
        if (method instanceof FullMethod) {
            return MethodKind.FULL;
        }
        if (method instanceof NmmMethod) {
            return MethodKind.NMM;
        }
        if (method instanceof PqMethod) {
            return MethodKind.PQ;
        }
        return method instanceof GemMethod ? MethodKind.GEM : MethodKind.REFERENCE;
    }

    /** What is fixed of a plan. */
    public static PlanRequest planRequest(Method method) {
        if (method instanceof FullMethod full) {
            return request(full.table(), full.neighbourhood(), full.area());
        }
        if (method instanceof NmmMethod nmm) {
            return request(nmm.table(), nmm.neighbourhood(), nmm.area());
        }
        if (method instanceof PqMethod pq) {
            return request(pq.table(), Optional.empty(), area(pq.repetition()));
        }
        TableChoices unused = TableChoices.of(Accuracy.ByTolerance.STANDARD);
        if (method instanceof GemMethod gem) {
            return request(unused, Optional.empty(), GaussianArea.STANDARD.with(gem.window()));
        }
        return ((ReferenceMethod) method).area() instanceof GaussianArea area
                ? request(unused, Optional.empty(), area)
                : request(unused, Optional.empty(), GaussianArea.STANDARD);
    }

    private static GaussianArea area(PqMethod.Repetition repetition) {
        CoherenceWindow window =
                repetition instanceof PqMethod.Filling filling ? filling.window() : GaussianArea.STANDARD.window();
        return GaussianArea.STANDARD.with(window);
    }

    private static PlanRequest request(TableChoices table, Optional<Neighbourhood> neighbourhood, GaussianArea area) {

        return new PlanRequest(
                table.accuracy().isThesis() ? PlanRequest.Preset.THESIS : PlanRequest.Preset.NONE,
                table.accuracy().tolerance().orElse(Tolerances.STANDARD),
                table.expansion(),
                table.terms(),
                neighbourhood.map(bins -> OptionalInt.of(bins.radius())).orElseGet(OptionalInt::empty),
                neighbourhood.map(Neighbourhood::anchor),
                table.wavelengthStep(),
                Optional.of(area.origin()),
                OptionalDouble.of(area.window().coherenceLength()),
                Optional.of(area.average()));
    }
}
