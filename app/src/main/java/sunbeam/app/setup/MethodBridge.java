package sunbeam.app.setup;

import java.util.OptionalDouble;
import java.util.OptionalInt;
import sunbeam.app.gpu.MethodKind;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.GemMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.plan.ReplicatedArea;
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
}
