/** Light from all directions: maps of radiance, their files, and the lights that stand for them. */
package sunbeam.app.scene.environment;
