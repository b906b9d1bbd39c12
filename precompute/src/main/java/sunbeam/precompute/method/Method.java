package sunbeam.precompute.method;

/** A diffraction method with all that a user fixes of it. Immutable; equal by value. */
public sealed interface Method permits FullMethod, NmmMethod, PqMethod, GemMethod, ReferenceMethod {
    /** Which method. */
    MethodType type();
}
