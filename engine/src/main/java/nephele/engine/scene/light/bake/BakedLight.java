package nephele.engine.scene.light.bake;

import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.level.placed.StaticShapes;

/**
 * Everything about light on the static geometry that is worked out before the first picture.
 *
 * @param visibility of the sky; its light map is also that of the indirect light
 * @param indirect {@code null} for a level whose light was not baked
 */
public record BakedLight(SkyVisibility visibility, IndirectLight indirect) {
    /** Returns the light before any bake: an open sky. */
    public static BakedLight open() {
        return new BakedLight(SkyVisibility.open(), null);
    }

    /** Returns the static geometry that it was baked for, models split. */
    public StaticShapes statics() {
        return visibility.statics();
    }

    public LightMapLayout layout() {
        return visibility.layout();
    }

    /** Returns the number here of a terrain of an edited level; {@link SkyVisibility#NEW} if none had its id. */
    public int groundOf(StaticShape.HeightGrid grid) {
        for (StaticShape.HeightGrid baked : statics().ground()) {
            if (baked.id().equals(grid.id())) {
                return statics().ground().indexOf(baked);
            }
        }
        return SkyVisibility.NEW;
    }

    /** Returns true if it was baked for solids of these shapes, so that the charts belong to the same indices. */
    public boolean isOf(List<Brush> solids) {
        return visibility.isOf(solids);
    }
}
