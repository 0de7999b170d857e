package nephele.scenes.fixed;

/** A term of the light model. */
public enum LightTerm {
    /** The scene's global ambient light, which is white; lights have no ambient part. */
    AMBIENT,
    DIFFUSE,
    SPECULAR,
    EMISSIVE
}
