package nephele.engine.render.fixed;

/** A summand of the light model. */
public enum LightTerm {
    /** Of the scene's global ambient light, which is white; lights have none of their own. */
    AMBIENT,
    DIFFUSE,
    SPECULAR,
    EMISSIVE
}
