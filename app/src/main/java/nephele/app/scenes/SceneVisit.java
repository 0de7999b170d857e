package nephele.app.scenes;

/**
 * A scene to be shown, with what is flown about in it and what is behind it.
 *
 * @param entity {@code null} for none
 * @param background an asset; {@code null} for none
 */
public record SceneVisit(SceneName scene, SceneName entity, String background) {
    /** Returns the visit of a scene of the game; only the sample has an entity and a background. */
    public static SceneVisit of(SceneName scene) {
        return scene.equals(SceneName.SAMPLE)
                ? new SceneVisit(scene, SceneName.SAMPLE_ENTITY, SceneName.SAMPLE_BACKGROUND)
                : new SceneVisit(scene, null, null);
    }
}
