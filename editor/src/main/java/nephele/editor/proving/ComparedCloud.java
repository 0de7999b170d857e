package nephele.editor.proving;

import nephele.editor.pane.PerspectiveCamera;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.host.compare.TechniquePair;

/**
 * A cloud that two techniques draw; all others keep theirs.
 *
 * @param id of the cloud
 */
public record ComparedCloud(
        Level level, AssetSource assets, String id, TechniquePair techniques, PerspectiveCamera camera) {
    private static final double NEAR_METRES = 0.05;

    /** Returns true if both give the same pictures; levels are compared by identity, since an edit makes a new one. */
    public boolean isSame(ComparedCloud other) {
        return isOfSameScenes(other) && camera.equals(other.camera);
    }

    boolean isOfSameScenes(ComparedCloud other) {
        return other != null
                && level == other.level
                && assets == other.assets
                && id.equals(other.id)
                && techniques.equals(other.techniques);
    }

    /**
     * Returns a level in which a technique draws the cloud.
     *
     * @param placed the level with the sun of its hour
     */
    Level drawnBy(CloudTechnique technique, Level placed) {
        Environment environment = placed.environment();
        Environment drawn = environment.withClouds(environment.clouds().stream()
                .map(cloud -> cloud.id().equals(id) ? cloud.with(technique) : cloud)
                .toList());
        return placed.with(drawn, placed.lights());
    }

    /** Returns the cloud of a level; {@code null} if it is gone. */
    public static Cloud find(Level level, String id) {
        return level.environment().clouds().stream()
                .filter(cloud -> cloud.id().equals(id))
                .findFirst()
                .orElse(null);
    }

    View view(double aspect) {
        Projection projection = new Projection(
                Math.toRadians(camera.verticalFovDegrees()), aspect, NEAR_METRES, Double.POSITIVE_INFINITY);
        return new View(
                camera.eye(), camera.right(), camera.up(), camera.forward().negated(), projection);
    }
}
