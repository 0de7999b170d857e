package nephele.engine.level;

import static nephele.engine.level.BadLevel.level;

import java.util.List;

/** Observers that nothing shows or moves, and pars that are none. */
final class BadObservers {
    private static final String CAMERA =
            "\"cameras\": [{\"id\": \"main\", \"position\": [0, 0, 5], \"target\": [0, 0, 0]}], ";
    private static final String PLAYER = "\"player\": {\"feet\": [0, 0, 0]}, ";

    static final List<BadLevel> ALL = List.of(
            level(
                    "observer.camera",
                    "no camera 'above': name one of the level",
                    CAMERA + PLAYER + "\"observer\": {\"camera\": \"above\"}"),
            level("observer.camera", "no camera that shows the sphere: add one", PLAYER + "\"observer\": {}"),
            level("observer", "there is no player: add one", CAMERA + "\"observer\": {}"),
            level(
                    "observer.radiusMetres",
                    "must be from 0.05 to 100",
                    CAMERA + PLAYER + "\"observer\": {\"radiusMetres\": 0}"),
            level("par.portals", "is missing", "\"par\": {\"seconds\": 3}"),
            level("par.seconds", "must be from 0.1 to 86400", "\"par\": {\"seconds\": 0, \"portals\": 1}"),
            level(
                    "observer.bounds",
                    "must be one of [sphere, box, oriented-box, tree, triangles]",
                    CAMERA + PLAYER + "\"observer\": {\"bounds\": \"cone\"}"));

    private BadObservers() {}
}
