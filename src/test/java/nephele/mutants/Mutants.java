package nephele.mutants;

import java.util.List;
import java.util.stream.Stream;

/** The planted faults. Each is of a kind that has occurred in development: a sign, a corner, a factor, an order. */
final class Mutants {
    static final String ENGINE = "engine/src/main/java/nephele/engine/";
    static final String SHADERS = "engine/src/main/resources/nephele/engine/render/";
    static final String SCENES = "scenes/src/main/";

    static final List<Mutant> ALL = Stream.of(
                    PictureMutants.ALL,
                    CollisionMutants.ALL,
                    PlacementMutants.ALL,
                    SimulationMutants.ALL,
                    LevelMutants.ALL,
                    ModelMutants.ALL,
                    SurfaceLightMutants.ALL,
                    SkyMutants.ALL,
                    GroundMutants.ALL,
                    WeatherMutants.ALL)
            .flatMap(List::stream)
            .toList();

    private Mutants() {}
}
