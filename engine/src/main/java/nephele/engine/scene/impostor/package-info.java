/**
 * Pictures of models from many directions, made once: {@code ImpostorAtlas} holds those of a kind from directions that
 * cover the hemisphere above the horizon, each an {@code AtlasView}.
 */
package nephele.engine.scene.impostor;
