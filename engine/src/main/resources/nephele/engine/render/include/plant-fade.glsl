// The share of a plant's pixels that its mesh draws; the impostor draws the others. Twin: render.pass.impostor.PlantChoice.

// Above this many times the size at which an impostor begins, only the mesh is drawn.
const float PLANT_FADE = java(render.pass.impostor.PlantChoice.FADE);

float plantMeshShare(float pixels) {
#ifdef ALWAYS_MESHES
    return 1.0;
#else
    return clamp((pixels / IMPOSTOR_PIXELS - 1.0) / (PLANT_FADE - 1.0), 0.0, 1.0);
#endif
}

// Below this size, in pixels, far plants are fewer and wider (Cook et al. 2007, "Stochastic Simplification of Aggregate
// Detail"): a plant is left out at a size of its own.
const float PLANT_THIN = java(render.pass.impostor.PlantChoice.THIN_PIXELS);
const float PLANT_SHRINK = java(render.pass.impostor.PlantChoice.SHRINK); // of all ranks are shrinking

// Returns the factor on the width of a plant; 0 if it is left out.
float plantWidening(float pixels, float rank) {
    float drawn = (1.0 + 0.5 * PLANT_SHRINK) * min(pixels / PLANT_THIN, 1.0);
    return clamp((drawn - rank) / PLANT_SHRINK + 0.5, 0.0, 1.0) / min(drawn, 1.0);
}
