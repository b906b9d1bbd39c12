/** From the command line's options to a patch, a plan and a table. */
package sunbeam.app.setup;
