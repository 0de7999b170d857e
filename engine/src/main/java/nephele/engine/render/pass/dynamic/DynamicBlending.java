package nephele.engine.render.pass.dynamic;

/** The blending of dynamic objects with the surfaces behind them. */
enum DynamicBlending {
    SOLID,
    /** Transparent except at edges: {@code held-look.glsl}. */
    SEE_THROUGH
}
