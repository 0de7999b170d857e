// The share of a plant's pixels that its mesh draws; the impostor draws the others. Twin: render.pass.impostor.PlantSizes.

// Above this many times the size at which an impostor begins, only the mesh is drawn.
const float PLANT_FADE = 1.2;

float plantMeshShare(float pixels) {
#ifdef ALWAYS_MESHES
    return 1.0;
#else
    return clamp((pixels / IMPOSTOR_PIXELS - 1.0) / (PLANT_FADE - 1.0), 0.0, 1.0);
#endif
}
