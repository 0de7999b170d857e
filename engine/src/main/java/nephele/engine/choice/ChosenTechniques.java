package nephele.engine.choice;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.cloud.drawn.CloudTimeline;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Aabb;
import nephele.engine.sim.reach.EyeReach;

/**
 * The techniques that draw the clouds of a level, those of its weather included: the written one, or the chosen one where
 * auto is written. They depend on the level and the table alone, so that every machine chooses the same.
 *
 * @param choices of the clouds in their order; {@code null} for a written technique
 */
public record ChosenTechniques(List<Cloud> clouds, List<TechniqueChoice> choices) {
    /** Returns the choices for a level, with the table of its folder. */
    public static ChosenTechniques of(PlacedLevel placed) {
        Environment environment = placed.level().environment();
        boolean isChosen =
                WeatherClouds.all(environment).stream().anyMatch(cloud -> cloud.technique() == CloudTechnique.AUTO);
        EyeReach reach = isChosen ? EyeReach.of(placed.level(), placed.statics()) : EyeReach.ANYWHERE;
        return of(environment, CloudColumns.of(environment, placed.assets()), reach, ErrorTable.of(placed.assets()));
    }

    /**
     * Returns the choices for an environment.
     *
     * @param columns of its clouds
     */
    public static ChosenTechniques of(Environment environment, CloudColumns columns, EyeReach reach, ErrorTable table) {
        double sunDegrees =
                Math.toDegrees(Math.asin(CloudTimeline.towardsSun(environment).y()));
        List<Cloud> clouds = columns.loaded().clouds();
        List<TechniqueChoice> choices = new ArrayList<>();
        for (int i = 0; i < clouds.size(); i++) {
            Cloud cloud = clouds.get(i);
            boolean isChosen = cloud.technique() == CloudTechnique.AUTO;
            choices.add(isChosen ? choice(cloud, i, columns, reach, sunDegrees, table) : null);
        }
        return new ChosenTechniques(clouds, choices);
    }

    private static TechniqueChoice choice(
            Cloud cloud, int index, CloudColumns columns, EyeReach reach, double sunDegrees, ErrorTable table) {
        Aabb bounds = columns.loaded().flat(index).bounds();
        double depth = columns.meanDepths().get(index);
        CloudSituation situation = CloudSituation.of(cloud, bounds, depth, reach, sunDegrees);
        String only = CloudSituation.formOfOnly(cloud);
        return TechniqueChoice.of(cloud, table.knows(only) ? situation.as(only) : situation, table);
    }

    /** Returns the technique of each cloud; none is auto. */
    public List<CloudTechnique> techniques() {
        List<CloudTechnique> techniques = new ArrayList<>();
        for (int i = 0; i < clouds.size(); i++) {
            TechniqueChoice choice = choices.get(i);
            techniques.add(
                    choice == null ? clouds.get(i).technique() : choice.chosen().technique());
        }
        return techniques;
    }
}
