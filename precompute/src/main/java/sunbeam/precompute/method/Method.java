package sunbeam.precompute.method;

import sunbeam.precompute.patch.HeightMap;

/** A diffraction method with all that a user fixes of it. Immutable; equal by value. */
public sealed interface Method permits FullMethod, NmmMethod, PqMethod, GemMethod, ReferenceMethod {
    /** Which method. */
    MethodType type();

    /** What it approximates, and is held against, on a surface. */
    ReferenceMethod exact(HeightMap map);
}
