package nephele.engine.reference;

import java.util.List;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.joml.Vector3dc;

/** The models that rays meet. The eye sees the fronts of their triangles; they shade from both sides. */
final class ModelForms {
    static final ModelForms NONE = new ModelForms(List.of());

    private final List<ModelForm> models;

    ModelForms(List<PlacedModel> models) {
        this.models = models.stream().map(ModelForm::new).toList();
    }

    int count() {
        return models.size();
    }

    List<Aabb> bounds() {
        return models.stream().map(ModelForm::bounds).toList();
    }

    /** The parameter at which the ray meets the first front; infinity where it does so before {@code least}, or never. */
    double entry(Ray ray, int model, double least) {
        return models.get(model).entry(ray, least);
    }

    /** Whether the ray meets any side up to the parameter {@code limit}. */
    boolean meets(Ray ray, int model, double limit) {
        return models.get(model).meets(ray, limit);
    }

    /**
     * What is met at a parameter that {@link #entry} has told.
     *
     * @param toEye unit
     */
    SurfacePoint at(int item, int model, Ray ray, double entry, Vector3dc toEye, Skins skins) {
        Vec3 place = ray.at(entry);
        return models.get(model).at(item, ray, entry, place, toEye, skins);
    }
}
