// Every wavelength node, expansion terms times a Gaussian neighbourhood of DFT bins: the thesis's FLSS (algorithm 3.3).

vec3 diffractedXyz(vec3 uvw) {
    vec3 xyz = vec3(0.0);
    for (int i = 0; i < wavelengthCount; ++i) {
        vec4 node = texelFetch(wavelengthNodes, ivec2(i, 0), 0);
#if AVERAGE == AVERAGE_ENSEMBLE
        xyz += node.yzw * ensemblePower(uvw, node.x);
#else
        xyz += node.yzw * coherentPower(uvw, node.x);
#endif
    }
    return xyz;
}
